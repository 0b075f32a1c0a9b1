-- SPDX-License-Identifier: Apache-2.0
-- The vote in Lua: rings in tables, statistics where they are asked for, an exact running sum where samples are whole.
local abs, ceil, floor = math.abs, math.ceil, math.floor

local function window(size)
    local w = {n = 0, next = 1, size = size, sorted = {}}
    for i = 1, size do w[i], w.sorted[i] = 0, 0 end
    return w
end

local function put(w, x)
    local i = w.next
    w[i] = x
    if i > w.n then w.n = i end
    if i == w.size then w.next = 1 else w.next = i + 1 end
end

local function median(w)
    local n, s = w.n, w.sorted
    for i = 1, n do
        local x, k = w[i], i - 1
        while k > 0 and s[k] > x do
            s[k + 1] = s[k]
            k = k - 1
        end
        s[k + 1] = x
    end
    if n % 2 == 1 then return s[(n + 1) / 2] end
    return (s[n / 2] + s[n / 2 + 1]) / 2
end

local function average(w)
    local sum, n = 0, w.n
    for i = 1, n do sum = sum + w[i] end
    return sum / n
end

local function range(w)
    local least, most = w[1], w[1]
    for i = 2, w.n do
        local x = w[i]
        if x < least then least = x end
        if x > most then most = x end
    end
    return most - least
end

return function(sv)
    local p1_5, p2_5, p3_5, p1_20, p2_20, p3_20, p1_50, a1_9, a2_15, a2_50, t2_3, t1_32, t1_sum
    local m1, m2, m3, number, state, first, start
    local all, two, failed

    local function go_to(to, f)
        number, state, first = to, f, true
    end

    local function medians()
        m1, m2, m3 = median(p1_5), median(p2_5), median(p3_5)
    end

    local function count(bad, away)
        if abs(away) <= 1.5 then return 0 end
        return bad < 65535 and bad + 1 or bad
    end

    function all()
        medians()
        local low, high = m1, m2
        if low > high then low, high = high, low end
        if m3 < high then high = m3 end
        local voted = low > high and low or high
        sv.voted, sv.slow, sv.spread = voted, average(p1_50), range(p2_20)
        local altitude = median(a1_9)
        local doubt = altitude - average(a2_50)
        sv.altitude, sv.band, sv.doubt, sv.warm = altitude, range(a2_15), doubt, t1_sum / t1_32.n
        local jump = median(t2_3) - sv.t2
        sv.jump = jump < 0 and ceil(jump) or floor(jump)
        local bad1, bad2, bad3 = count(sv.bad1, m1 - voted), count(sv.bad2, m2 - voted), count(sv.bad3, m3 - voted)
        sv.bad1, sv.bad2, sv.bad3 = bad1, bad2, bad3
        local healthy = (bad1 < 10 and 1 or 0) + (bad2 < 10 and 1 or 0) + (bad3 < 10 and 1 or 0)
        sv.healthy = healthy
        sv.stuck = range(p1_20) == 0 or range(p3_20) == 0
        sv.split = abs(doubt) > 8
        if healthy < 3 then go_to(2, two) end
    end

    function two()
        medians()
        if sv.bad1 >= 10 then
            sv.voted = (m2 + m3) / 2
        elseif sv.bad2 >= 10 then
            sv.voted = (m1 + m3) / 2
        else
            sv.voted = (m1 + m2) / 2
        end
        local spread, band = range(p2_20), range(a2_15)
        sv.spread, sv.altitude, sv.band = spread, median(a1_9), band
        if spread > 6 or band > 12 then
            go_to(3, failed)
        elseif sv.reset and sv.time - start > 500 then
            go_to(1, all)
        end
    end

    function failed(is_first)
        if is_first then sv.voted = 0 end
        sv.altitude = median(a1_9)
        if sv.reset then
            sv.bad1, sv.bad2, sv.bad3 = 0, 0, 0
            go_to(1, all)
        end
    end

    local function init()
        p1_5, p2_5, p3_5, p1_20, p2_20, p3_20 = window(5), window(5), window(5), window(20), window(20), window(20)
        p1_50, a1_9, a2_15, a2_50, t2_3, t1_32 = window(50), window(9), window(15), window(50), window(3), window(32)
        m1, m2, m3, number, state, first, start, t1_sum = 0, 0, 0, 1, all, true, 0, 0
        for name in ("voted slow spread altitude band doubt warm jump bad1 bad2 bad3 healthy"):gmatch("%w+") do sv[name] = 0 end
        sv.state, sv.stuck, sv.split = 1, false, false
    end

    local function step()
        local is_first = first
        if is_first then
            first = false
            start = sv.time
            sv.state = number
        end
        local p1, p2, p3, a2, t1 = sv.p1, sv.p2, sv.p3, sv.a2, sv.t1
        put(p1_5, p1)
        put(p2_5, p2)
        put(p3_5, p3)
        put(p1_20, p1)
        put(p2_20, p2)
        put(p3_20, p3)
        put(p1_50, p1)
        put(a1_9, sv.a1)
        put(a2_15, a2)
        put(a2_50, a2)
        put(t2_3, sv.t2)
        t1_sum = t1_sum + t1 - t1_32[t1_32.next]
        put(t1_32, t1)
        state(is_first)
    end

    return step, init
end
