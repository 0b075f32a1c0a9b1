-- SPDX-License-Identifier: Apache-2.0
-- The mission in Lua: a closure over its state, a function a state.  The windows are rings in tables; what is asked for is
-- worked out where it is asked for.
local abs = math.abs

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

-- By insertion: with eleven samples faster than table.sort.
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

local function highest(w)
    local most = w[1]
    for i = 2, w.n do
        local x = w[i]
        if x > most then most = x end
    end
    return most
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
    local altitudes, accelerations, span
    local ground, top, peak, calm, ignitions
    local number, state, first, start, in_state
    local safe, armed, ignition, boost, coast, apogee, drogue, main, landed, aborted

    local function change(to, f)
        number, state, first = to, f, true
    end

    local function fault(n)
        local faults = sv.faults + n
        if faults > 255 then faults = 255 end
        sv.faults = faults
    end

    function safe(is_first)
        if is_first then
            sv.igniter, sv.drogue, sv.mainChute, sv.beacon = false, false, false, false
        end
        ground = median(altitudes)
        sv.height = 0
        local battery = sv.battery
        if battery < 11000 then fault(1) end
        if sv.armSwitch and battery >= 11000 and in_state > 500 and range(span) < 5 then change(2, armed) end
    end

    function armed(is_first)
        if is_first then top, peak = 0, 0 end
        local height = median(altitudes) - ground
        sv.height = height
        if not sv.armSwitch or sv.battery < 11000 or abs(height) > 20 then
            change(1, safe)
        elseif sv.launchButton and in_state > 1000 then
            change(3, ignition)
        end
    end

    function ignition(is_first)
        if is_first then
            sv.igniter = true
            ignitions = ignitions + 1
        end
        sv.height = median(altitudes) - ground
        local load = average(accelerations)
        sv.load = load
        if sv.acceleration > 25 and load > 12.5 then
            sv.igniter = false
            change(4, boost)
        elseif in_state > 2000 then
            fault(16)
            sv.igniter = false
            change(10, aborted)
        end
    end

    function boost()
        local height, load = median(altitudes) - ground, average(accelerations)
        sv.height, sv.load = height, load
        if height > top then top = height end
        if load > peak then peak = load end
        if in_state > 500 and load < 0 then
            change(5, coast)
        elseif in_state > 4500 then
            fault(1)
            change(5, coast)
        end
    end

    function coast()
        local height = median(altitudes) - ground
        sv.height = height
        if height > top then top = height end
        if in_state > 1000 and height < top - 2 then
            change(6, apogee)
        elseif in_state > 30000 then
            fault(1)
            change(6, apogee)
        end
    end

    function apogee(is_first)
        if is_first then
            sv.apogee = top
            sv.drogue = true
        end
        sv.height = median(altitudes) - ground
        sv.load = average(accelerations)
        if in_state > 500 and highest(span) - ground < sv.apogee - 4 then
            change(7, drogue)
        elseif in_state > 5000 then
            change(8, main)
        end
    end

    function drogue()
        local height = median(altitudes) - ground
        sv.height, sv.load = height, average(accelerations)
        if range(span) > 30 then fault(1) end
        if height < 300 or in_state > 300000 then
            sv.drogue = false
            change(8, main)
        end
    end

    function main(is_first)
        if is_first then
            sv.mainChute = true
            calm = 0
        end
        local height = median(altitudes) - ground
        sv.height = height
        if range(span) < 2 then calm = calm + 1 else calm = 0 end
        if (calm > 100 and height < 50) or in_state > 300000 then
            sv.mainChute = false
            change(9, landed)
        end
    end

    function landed(is_first)
        if is_first then sv.beacon = true end
        sv.load = average(accelerations)
        if sv.battery < 10000 and in_state > 60000 then sv.beacon = false end
    end

    function aborted(is_first)
        if is_first then sv.beacon = true end
        local height = median(altitudes) - ground
        sv.height = height
        if not sv.armSwitch and abs(height) < 20 and in_state > 5000 then change(1, safe) end
    end

    local function init()
        altitudes, accelerations, span = window(11), window(20), window(15)
        ground, top, peak, calm, ignitions = 0, 0, 0, 0, 0
        number, state, first, start, in_state = 1, safe, true, 0, 0
        sv.state, sv.load, sv.height, sv.apogee, sv.faults = 1, 0, 0, 0, 0
        sv.igniter, sv.drogue, sv.mainChute, sv.beacon = false, false, false, false
    end

    local function step()
        local is_first = first
        if is_first then
            first = false
            start = sv.time
            sv.state = number
        end
        in_state = sv.time - start
        local altitude = sv.altitude
        put(altitudes, altitude)
        put(accelerations, sv.acceleration)
        put(span, altitude)
        state(is_first)
    end

    return step, init
end
