-- SPDX-License-Identifier: Apache-2.0
-- The pressures, in Lua: each condition has a number, and the time since which it is true; if it is false, that is infinite.
local abs, floor, never = math.abs, math.floor, math.huge
local STUCK, HIGH, LEAK = 0, 4, 8          -- and the number of a pressure, from 1
local ARMED, LINKED, UNLINKED, ALARM, FILLED, NEAR, CALM, FALLS, VENTED = 13, 14, 15, 16, 17, 18, 19, 20, 21

local function limit(x, least, most)
    if x < least then return least end
    if x > most then return most end
    return x
end

local function whole(x) return x < 0 and -floor(-x) or floor(x) end

return function(sv)
    local since, ring, ringTime, before, heat, mean, meanTime
    local state, number, first, start, last, now, n, currents
    local wasPressed, wasKey, wasLink, wasArmed, pressed, key, unlinked, disarmed, jump
    local rate = {0, 0, 0, 0}

    local function init()
        for name in ("slope drift trend presses score balance lost tries done"):gmatch("%w+") do sv[name] = 0 end
        sv.state, sv.valve, sv.vent, sv.alarm, sv.horn = 1, false, false, false, false
        since, ring, ringTime, before, heat, mean, meanTime = {}, {{}, {}, {}, {}}, {}, {}, {}, {}, {}
        number, first, start, last, n, currents = 1, true, 0, nil, 0, 0
        for k = 1, VENTED do since[k] = never end
    end

    local function note(which, c)
        if not c then
            since[which] = never
        elseif since[which] == never then
            since[which] = now
        end
    end

    local function held(which, t)
        return now - since[which] >= t
    end

    local function pressure(i, x, newest, oldest)
        local r, was = ring[i], before[i] or x
        r[newest] = x
        local speed = n > 0 and (x - r[oldest]) / ((now - ringTime[oldest]) / 1000) or 0
        rate[i] = speed
        note(STUCK + i, x == was)
        note(HIGH + i, x > 40)
        note(LEAK + i, speed < -25)
        if abs(x - was) > 4 then jump = true end
        before[i] = x
    end

    local function sample()
        local newest, oldest = n % 6, n < 6 and 0 or (n + 1) % 6
        ringTime[newest] = now
        jump = false
        pressure(1, sv.p0, newest, oldest)
        pressure(2, sv.p1, newest, oldest)
        pressure(3, sv.p2, newest, oldest)
        pressure(4, sv.p3, newest, oldest)
        local isKey, link, armed, vent = sv.key, sv.link, sv.armed, sv.vent
        note(ARMED, armed)
        note(LINKED, link)
        note(UNLINKED, not link)
        note(ALARM, sv.alarm)
        note(FILLED, sv.p0 > 15)
        note(NEAR, abs(sv.p0 - sv.p3) < 6)
        note(CALM, abs(rate[1]) < 60)
        note(FALLS, vent and sv.slope < 0)
        note(VENTED, vent)
        currents = sv.current > 100 and currents + 1 or 0
        local isPressed = isKey and held(ARMED, 50) or false
        pressed = n > 0 and isPressed and not wasPressed
        key = n > 0 and isKey and not wasKey
        unlinked = n > 0 and not link and wasLink
        disarmed = n > 0 and not armed and wasArmed
        wasPressed, wasKey, wasLink, wasArmed = isPressed, isKey, link, armed
    end

    local function drift()
        heat[n % 11] = sv.heat
        local sum, count = 0, n < 10 and n + 1 or 11
        for i = 0, count - 1 do sum = sum + heat[i] end
        local newest, oldest = n % 31, n < 31 and 0 or (n + 1) % 31
        mean[newest], meanTime[newest] = sum / count, now
        return n > 0 and (mean[newest] - mean[oldest]) / ((now - meanTime[oldest]) / 1000) or 0
    end

    local function all_states()
        local score, balance, trend = sv.score - 3 + (jump and 60 or 0), sv.balance, drift()
        for i = 1, 4 do
            if held(STUCK + i, 60) then score = score + 40 end
            if held(HIGH + i, 30) then score = score + 25 end
            if held(LEAK + i, 40) then balance = balance + (i < 3 and 1 or -1) end
        end
        sv.score, sv.balance = limit(score, 0, 255), limit(balance, -128, 127)
        sv.slope = (rate[1] + rate[2] + rate[3] + rate[4]) / 4
        sv.drift = trend
        sv.trend = limit(whole(sv.trend + trend * 50), -32768, 32767)
        if pressed then sv.presses = sv.presses + 1 end
        if unlinked then
            sv.lost = limit(sv.lost + 30, 0, 255)
        elseif held(LINKED, 200) then
            sv.lost = limit(sv.lost - 1, 0, 255)
        end
        sv.alarm = sv.score > 200 or held(UNLINKED, 150) or sv.lost == 255
        sv.horn = held(ALARM, 100) and not held(ARMED, 500)
    end

    state = {}
    state[1] = {
        entry = function() sv.valve, sv.vent = false, false end,
        step = function() return held(ARMED, 50) and key and 2 end,
        exit = function() sv.tries = limit(sv.tries + 1, 0, 255) end,
    }
    state[2] = {
        entry = function() sv.valve = true end,
        step = function(T)
            if not held(FILLED, 30) then return T > 300 and 6 end
            if held(HIGH + 2, 30) or held(HIGH + 3, 30) then return 6 end
            return held(NEAR, 20) and 3 or T > 150 and 6
        end,
        exit = function() sv.valve = false end,
    }
    state[3] = {
        entry = function() sv.balance = 0 end,
        step = function(T)
            if held(LEAK + 1, 40) or held(LEAK + 4, 40) then return 6 end
            return T >= 50 and held(CALM, 30) and 4 or T > 400 and 6
        end,
    }
    state[4] = {
        step = function(T)
            if sv.alarm or not held(LINKED, 20) then return 6 end
            return currents >= 3 and 5 or T > 500 and 6
        end,
    }
    state[5] = {
        entry = function() sv.vent = true end,
        step = function(T) return (T >= 100 or held(FALLS, 20)) and 6 end,
        exit = function() sv.done, sv.score = sv.done + 1, floor(sv.score / 2) end,
    }
    state[6] = {
        entry = function() sv.vent, sv.trend = true, 0 end,
        step = function(T) return (T >= 120 or disarmed and held(VENTED, 30)) and 1 end,
        exit = function() sv.lost, sv.vent = floor(sv.lost / 2), false end,
    }

    local function step()
        now = sv.time
        if last and now - last > 20 then
            for k = 1, VENTED do since[k] = never end
        end
        last = now
        sample()
        local s = state[number]
        if first then
            first = false
            start = now
            sv.state = number
            if s.entry then s.entry() end
        end
        all_states()
        n = n + 1
        local to = s.step(now - start)
        if to then
            if s.exit then s.exit() end
            number, first = to, true
        end
    end

    return step, init
end
