-- SPDX-License-Identifier: Apache-2.0
-- The red lines in Lua: the last samples of each sensor in arrays.
local least = {-20, -21, -22, -23, -24, -25, -26, -27, -28, -29, -30, -31, -32, -33, -34, -35, -36, -37, -38, -39, -40, -41, -42, -43}
local most = {60, 63, 66, 69, 72, 75, 61, 64, 67, 70, 73, 76, 62, 65, 68, 71, 74, 60, 63, 66, 69, 72, 75, 61}

local function median(a, b, c)
    if a > b then a, b = b, a end
    if c >= b then return b end
    return c > a and c or a
end

return function(sv)
    local sample, name = {}, {}
    local n, number, first, start

    local function init()
        for k = 1, 4 do
            sample[k] = {}
            for i = 1, 24 do sample[k][i] = 0 end
        end
        for i = 1, 24 do name[i] = "s" .. i - 1 end
        sv.state, sv.hottest, sv.trips, sv.code, sv.closed = 1, 0, 0, 0, false
        n, number, first, start = 0, 1, true, 0
    end

    local function put()
        local new = table.remove(sample)
        table.insert(sample, 1, new)
        for i = 1, 24 do new[i] = sv[name[i]] end
        n = n + 1
    end

    local function average(i)
        local sum, count = 0, n < 4 and n or 4
        for k = 1, count do sum = sum + sample[k][i] end
        return sum / count
    end

    local function violated()
        local a, b, c = sample[1], sample[2], sample[3]
        for i = 1, 24 do
            local x
            if n > 2 then
                x = median(a[i], b[i], c[i])
            elseif n == 2 then
                x = (a[i] + b[i]) / 2
            else
                x = a[i]
            end
            if not (least[i] < x and x < most[i]) then return i end
        end
    end

    local function run(is_first)
        if is_first then sv.closed = false end
        sv.hottest = math.max(average(1), average(2), average(3), average(4))
        local code = violated()
        if code then
            sv.code = code
            number, first = 2, true
        end
    end

    local function tripped(is_first)
        if is_first then
            sv.closed = true
            sv.trips = sv.trips + 1
        end
        if sv.reset and sv.time - start > 30 then number, first = 1, true end
    end

    local function step()
        local is_first = first
        if is_first then
            first = false
            start = sv.time
            sv.state = number
        end
        put()
        if number == 1 then run(is_first) else tripped(is_first) end
    end

    return step, init
end
