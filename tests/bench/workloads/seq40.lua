-- SPDX-License-Identifier: Apache-2.0
-- The launch sequencer in Lua: a closure over its state, a function a state, made by a function for each kind.
return function(sv)
    local start, first, number, state, in_state
    local states = {}
    local go_to

    function go_to(to)
        number, state, first = to, states[to], true
    end

    local function stops()
        if sv.stop or sv.bus < 22000 then
            go_to(40)
            return true
        end
    end

    local function valve(name, value, wait, next)
        return function(is_first)
            if is_first then sv[name] = value end
            if not stops() and in_state >= wait then go_to(next) end
        end
    end

    local function cool(limit, most, next)
        return function(is_first)
            if is_first then sv.chillValve = true end
            if not stops() then
                if sv.chill < limit then go_to(next) elseif in_state > most then go_to(39) end
            end
            if first then sv.chillValve = false end
        end
    end

    local function count(from, next)
        return function(is_first)
            if is_first then sv.count = from end
            if not stops() then
                local n = sv.count
                if n > 0 then
                    n = n - 1
                    sv.count = n
                end
                if not sv.go then go_to(39) elseif n == 0 then go_to(next) end
            end
        end
    end

    local function press(name, out, least, most, longest, next)
        return function(is_first)
            if is_first then sv[out] = true end
            if not stops() then
                local pressure = sv[name]
                if pressure > most then go_to(40) elseif pressure >= least then go_to(next) elseif in_state > longest then go_to(39) end
            end
            if first then sv[out] = false end
        end
    end

    local function settle(name, least, wait, next)
        return function(is_first)
            local pressure = sv[name]
            if is_first then sv.lowest = pressure end
            if not stops() then
                if pressure < sv.lowest then sv.lowest = pressure end
                if in_state >= wait then go_to(sv.lowest > least and next or 39) end
            end
        end
    end

    states[1] = function() if not stops() and sv.go and in_state >= 200 then go_to(2) end end
    states[2] = valve("lights", true, 300, 3)
    states[3] = valve("camera", true, 450, 4)
    states[4] = valve("loxVent", true, 800, 5)
    states[5] = valve("fuelVent", true, 700, 6)
    states[6] = valve("purge", true, 1500, 7)
    states[7] = valve("purge", false, 400, 8)
    states[8] = cool(-60, 9000, 9)
    states[9] = valve("camera", true, 900, 10)
    states[10] = cool(-120, 9000, 11)
    states[11] = count(40, 12)
    states[12] = valve("loxVent", false, 350, 13)
    states[13] = press("lox", "pressLox", 20, 30, 6000, 14)
    states[14] = settle("lox", 12, 800, 15)
    states[15] = press("lox", "pressLox", 30, 42, 6000, 16)
    states[16] = settle("lox", 22, 900, 17)
    states[17] = valve("fuelVent", false, 350, 18)
    states[18] = press("fuel", "pressFuel", 18, 30, 6000, 19)
    states[19] = settle("fuel", 10, 700, 20)
    states[20] = press("fuel", "pressFuel", 28, 42, 6000, 21)
    states[21] = settle("fuel", 20, 900, 22)
    states[22] = count(55, 23)
    states[23] = valve("armed", true, 500, 24)
    states[24] = press("lox", "pressLox", 32, 42, 6000, 25)
    states[25] = press("fuel", "pressFuel", 30, 42, 6000, 26)
    states[26] = valve("purge", true, 600, 27)
    states[27] = valve("purge", false, 250, 28)
    states[28] = count(100, 29)
    states[29] = valve("igniter", true, 450, 30)
    states[30] = valve("fuelMain", true, 120, 31)
    states[31] = valve("loxMain", true, 150, 32)
    states[32] = valve("igniter", false, 300, 33)
    states[33] = function()
        if not stops() then
            local chamber = sv.chamber
            if in_state > 200 and chamber < 8 or chamber > 60 then go_to(40) elseif in_state >= 1800 then go_to(34) end
        end
    end
    states[34] = valve("fuelMain", false, 100, 35)
    states[35] = valve("loxMain", false, 400, 36)
    states[36] = valve("purge", true, 900, 37)
    states[37] = valve("purge", false, 500, 38)
    states[38] = valve("armed", false, 600, 1)
    states[39] = function(is_first)
        if is_first then
            if sv.holds < 255 then sv.holds = sv.holds + 1 end
            sv.pressLox, sv.pressFuel, sv.chillValve = false, false, false
        end
        if sv.stop then go_to(40) elseif sv.go and in_state >= 500 then go_to(2) elseif in_state > 20000 then go_to(40) end
    end
    states[40] = function(is_first)
        if is_first then
            sv.loxMain, sv.fuelMain, sv.igniter, sv.pressLox, sv.pressFuel, sv.chillValve, sv.armed = false, false, false, false, false, false, false
            sv.loxVent, sv.fuelVent = true, true
        end
        if not sv.stop and in_state >= 1000 then go_to(1) end
    end

    local function init()
        start, first, number, state, in_state = 0, true, 1, states[1], 0
        sv.state, sv.lowest, sv.count, sv.holds = 1, 0, 0, 0
        for name in ("loxVent fuelVent loxMain fuelMain purge igniter pressLox pressFuel chillValve armed lights camera"):gmatch("%w+") do sv[name] = false end
    end

    local function step()
        local is_first = first
        if is_first then
            first = false
            start = sv.time
            sv.state = number
        end
        in_state = sv.time - start
        state(is_first)
    end

    return step, init
end
