-- SPDX-License-Identifier: Apache-2.0
-- The sixteen channels in Lua: arrays and a loop.
local floor, ceil, abs = math.floor, math.ceil, math.abs

return function(sv)
    local position, distance, peak, next, last, name = {}, {}, {}, {}, {}, {}
    local number, first, start

    local function clear()
        for i = 1, 16 do position[i], distance[i], peak[i] = 0, 0, 0 end
    end

    local function init()
        clear()
        for i = 1, 16 do next[i], last[i], name[i] = 0, 0, "in" .. i - 1 end
        sv.state, sv.position, sv.worst, sv.distance, sv.age, sv.checks, sv.late, sv.mean, sv.full = 1, 0, 0, 0, 0, 0, 0, 0, false
        number, first, start = 1, true, 0
    end

    local function ledger()
        local total, way, worst, late, time = 0, 0, 0, 0, sv.time
        for i = 1, 16 do
            local x = sv[name[i]]
            local p, d, k = position[i] + x * (i + 2), distance[i] + abs(x - last[i]), peak[i]
            position[i], distance[i], last[i] = p, d, x
            local size = abs(p)
            if size > k then
                k = size
                peak[i] = k
            end
            if time >= next[i] then
                next[i] = time + 7000 * i
                late = late + 1
            end
            total, way = total + p, way + d
            if k > worst then worst = k end
        end
        sv.late, sv.position, sv.distance, sv.worst = sv.late + late, total, way, worst
        local mean = total / 1000
        sv.mean = mean < 0 and ceil(mean) or floor(mean)
        sv.age = start + way * 3
        sv.checks = sv.checks + floor(way / 16)
        sv.full = way > 4000000000 or worst > 9000000000
        if sv.clear then number, first = 2, true end
    end

    local function step()
        if first then
            first = false
            start = sv.time
            sv.state = number
        end
        if number == 1 then
            ledger()
        else
            clear()
            number, first = 1, true
        end
    end

    return step, init
end
