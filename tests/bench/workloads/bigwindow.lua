-- SPDX-License-Identifier: Apache-2.0
-- The large window in Lua: a ring, and beside it the same samples in order, moved between two places found by binary search.
local floor = math.floor

-- table.move where it is (Lua 5.3, LuaJIT 2.1).
local move = table.move or function(t, from, to, at)
    if at > from then
        for i = to, from, -1 do t[at + i - from] = t[i] end
    else
        for i = from, to do t[at + i - from] = t[i] end
    end
end

local function place(sorted, n, x)      -- where the first stands that is not less than x
    local lo, hi = 1, n + 1
    while lo < hi do
        local mid = floor((lo + hi) / 2)
        if sorted[mid] < x then lo = mid + 1 else hi = mid end
    end
    return lo
end

return function(sv)
    local size = 1001
    local sample, sorted, n, next_one, first

    local function put(x)
        local from = n < size and n + 1 or place(sorted, n, sample[next_one])
        local to = place(sorted, n, x)
        if from < to then
            to = to - 1
            move(sorted, from + 1, to, from)
        elseif to < from then
            move(sorted, to, from - 1, to + 1)
        end
        sorted[to] = x
        sample[next_one] = x
        next_one = next_one < size and next_one + 1 or 1
        if n < size then n = n + 1 end
    end

    local function init()
        sample, sorted, n, next_one, first = {}, {}, 0, 1, true
        sv.state, sv.middle, sv.low, sv.high = 1, 0, 0, 0
    end

    local function step()
        if first then
            first = false
            sv.state = 1
        end
        put(sv.pressure)
        if n % 2 == 1 then
            sv.middle = sorted[(n + 1) / 2]
        else
            sv.middle = (sorted[n / 2] + sorted[n / 2 + 1]) / 2
        end
        sv.low = sorted[1]
        sv.high = sorted[n]
    end

    return step, init
end
