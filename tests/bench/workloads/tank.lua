-- SPDX-License-Identifier: Apache-2.0
-- The tank in Lua: a closure over its state, a function a state.
return function(sv)
    local counter, start, first, number, state

    local function stay() end

    local function leave(to, f)
        sv.valveOpen = true
        number, state, first = to, f, true
    end

    local function vent_control()
        local pressure = sv.tankPressure
        if pressure > 775 then
            sv.valveOpen = true
            counter = counter + 1
        else
            sv.valveOpen = false
        end
        if pressure <= 500 or pressure >= 825 then
            leave(3, stay)
        elseif counter > 1000 and sv.time - start > 4000 then
            leave(2, stay)
        end
    end

    local function init()
        counter, start, first, number, state = 0, 0, true, 1, vent_control
        sv.state, sv.valveOpen = 1, false
    end

    local function step()
        if first then
            first = false
            start = sv.time
            counter = 0
            sv.state = number
        end
        state()
    end

    return step, init
end
