-- SPDX-License-Identifier: Apache-2.0
-- The counters in Lua, with limits where they can be reached.
local ceil, floor, abs = math.ceil, math.floor, math.abs

local function limit(x, least, most)
    if x < least then return least end
    if x > most then return most end
    return x
end

return function(sv)
    local before, last, tenths, first

    local function init()
        for name in ("ticks pulses travel energy balance error position faults high quiet span turn drift rate debounce leak retries seconds minutes score tilt bias"):gmatch("%w+") do
            sv[name] = 0
        end
        sv.state, sv.alarm, sv.steady, sv.late = 1, false, false, false
        before, last, tenths, first = 0, 0, 0, true
    end

    local function clock()
        tenths = tenths + 1
        if tenths >= 10 then
            tenths = 0
            local seconds = limit(sv.seconds + 1, 0, 255)
            if seconds >= 60 then
                seconds = 0
                sv.minutes = limit(sv.minutes + 1, 0, 255)
            end
            sv.seconds = seconds
        end
    end

    local function step()
        local adc0, adc1, encoder, mode, pulse, fault = sv.adc0, sv.adc1, sv.encoder, sv.mode, sv.pulse, sv.fault
        local moved, trim = encoder - before, sv.trim
        if first then
            first = false
            sv.state = 1
        end
        before = encoder
        sv.ticks = limit(sv.ticks + 1, 0, 4294967295)
        local pulses = sv.pulses
        if pulse then
            pulses = limit(pulses + 1, 0, 4294967295)
            sv.pulses = pulses
        end
        local travel = limit(sv.travel + abs(moved), 0, 4294967295)
        sv.travel = travel
        sv.position = limit(sv.position + moved, -2147483648, 2147483647)
        sv.rate = limit(moved, -32768, 32767)
        sv.energy = limit(sv.energy + adc0 * mode, 0, 4294967295)
        sv.balance = limit(sv.balance + adc0 - adc1, -2147483648, 2147483647)
        sv.error = limit(encoder - 1000 * mode, -2147483648, 2147483647)
        local faults, score, leak = sv.faults, sv.score, sv.leak
        if fault then
            faults, score, leak = limit(faults + 1, 0, 65535), limit(score - 20, -128, 127), limit(leak + 39, 0, 255)
        else
            score, leak = limit(score + 1, -128, 127), limit(leak - 1, 0, 255)
        end
        sv.faults, sv.score, sv.leak = faults, score, leak
        local high = sv.high - 3
        if adc0 > high then high = adc0 end
        sv.high = high
        local quiet = 0
        if adc0 <= 100 then quiet = limit(sv.quiet + 1, 0, 65535) end
        sv.quiet = quiet
        local span = abs(adc0 - last)
        sv.span = span
        last = adc0
        sv.turn = limit(sv.turn + sv.gyro, -32768, 32767)
        local drift = sv.drift - sv.gyro / 16 + trim
        sv.drift = limit(drift < 0 and ceil(drift) or floor(drift), -32768, 32767)
        local debounce = pulse and limit(sv.debounce + 16, 0, 255) or limit(sv.debounce - 9, 0, 255)
        sv.debounce = debounce
        if mode == 3 then sv.retries = limit(sv.retries + 1, 0, 255) elseif mode == 0 then sv.retries = 0 end
        clock()
        sv.tilt = limit(trim * 3 + mode, -128, 127)
        if adc0 > adc1 then sv.bias = limit(sv.bias + 1, -128, 127) elseif adc0 < adc1 then sv.bias = limit(sv.bias - 1, -128, 127) end
        sv.alarm = leak > 100 or score < -100 or faults > 1000
        sv.steady = debounce == 255 and span < 50
        sv.late = travel - pulses * 4 > 100000 or quiet > 500
    end

    return step, init
end
