-- SPDX-License-Identifier: Apache-2.0
-- 200 states in Lua: a function a state, made by a function for each kind.
return function(sv)
    local number, state
    local states = {}

    local function go_to(to)
        number, state = to, states[to]
    end

    local kinds = {}

    kinds[0] = function(i, a, one, other)
        return function()
            local total = sv.total * 0.5 + sv.rate * a
            sv.total = total
            if total > 0 then go_to(one) else go_to(other) end
        end
    end

    kinds[1] = function(i, a, one, other)
        return function()
            local sum = sv.sum + a
            if sum > 100000 then sum = 0 end
            sv.sum = sum
            if sv.level > a then go_to(one) else go_to(other) end
        end
    end

    kinds[2] = function(i, a, one, other)
        return function()
            sv.marks = i
            sv.open = not sv.open
            if sv.level < a then go_to(one) else go_to(other) end
        end
    end

    kinds[3] = function(i, a, one, other)
        return function()
            local open = sv.level > a and sv.ready
            sv.open = open
            if open then go_to(one) else go_to(other) end
        end
    end

    kinds[4] = function(i, a, one, other)
        return function()
            if sv.ready then
                if sv.run < 255 then sv.run = sv.run + 1 end
                go_to(one)
            else
                sv.run = 0
                go_to(other)
            end
        end
    end

    for i = 0, 199 do
        states[i + 1] = kinds[i % 5](i, 10 + i * 37 % 80, (i * 73 + 11) % 200 + 1, (i * 31 + 7) % 200 + 1)
    end

    local function init()
        number, state = 1, states[1]
        sv.state, sv.total, sv.sum, sv.marks, sv.run, sv.open = 1, 0, 0, 0, 0, false
    end

    local function step()
        sv.state = number
        state()
    end

    return step, init
end
