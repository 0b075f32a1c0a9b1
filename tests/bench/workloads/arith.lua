-- SPDX-License-Identifier: Apache-2.0
-- The arithmetic in Lua.  Every number of Lua's is one of the language's; where a value can leave its type it is cut off as there.
local floor, ceil, abs, max, min = math.floor, math.ceil, math.abs, math.max, math.min

local function trunc(x)
    return x < 0 and ceil(x) or floor(x)
end

local function cut(x, least, most)
    if x <= least then return least end
    if x >= most then return most end
    return x < 0 and ceil(x) or floor(x)
end

return function(sv)
    local gyro_scale = 0.00106
    local drift, last, bad, before, first

    local function units()
        local adc0, adc1, adc2 = sv.adc0, sv.adc1, sv.adc2
        local volts0, volts1 = adc0 * 5 / 4096, adc1 * 5 / 4096
        local current = (volts0 - 2.5) / 0.066
        local power = current * volts1
        local celsius = adc2 * 3.3 / 4096 * 100 - 50
        local kelvin, pressure, airspeed = celsius + 273.15, sv.pressure, sv.airspeed
        local density = pressure / (kelvin * 0.287)
        sv.volts0, sv.volts1, sv.current, sv.power = volts0, volts1, current, power
        sv.energy = sv.energy + power * 0.02
        sv.celsius, sv.kelvin = celsius, kelvin
        sv.rateX, sv.rateY, sv.rateZ = sv.gyroX * gyro_scale, sv.gyroY * gyro_scale, sv.gyroZ * gyro_scale
        sv.altitude = (101.325 - pressure) * 84.3
        sv.density = density
        sv.lift = density * airspeed * airspeed / 2
    end

    local function whole()
        local x, y, z, trim = sv.gyroX, sv.gyroY, sv.gyroZ, sv.trim
        local sum = x + y + z
        sv.turn = cut(sum, -32768, 32767)
        sv.mean = trunc(sum / 3)
        sv.trimmed = cut(x - trim, -32768, 32767)
        sv.half = trunc(z / 256)
        sv.tilt = cut(y / 64 + trim, -128, 127)
        sv.spin = x * x + y * y
        sv.product = x * sv.adc1
        sv.miss = sv.setpoint - sv.encoder
        sv.level = floor(sv.adc2 / 16)
    end

    local function counters()
        local adc0, adc1, encoder = sv.adc0, sv.adc1, sv.encoder
        local ticks = sv.ticks + 1
        sv.ticks = ticks
        sv.beats = min(sv.beats + sv.mode, 255)
        sv.total = sv.total + adc0 + adc1
        sv.balance = sv.balance + adc0 - adc1
        sv.position = sv.position + encoder
        sv.pulses = sv.pulses + abs(encoder - before)
        before = encoder
        local minutes = floor(ticks / 3000)
        sv.minutes = minutes
        sv.rest = ticks - minutes * 3000
    end

    local function filters()
        local adc0, adc1, adc2 = sv.adc0, sv.adc1, sv.adc2
        local smooth, high, low = sv.smooth, sv.high, sv.low
        sv.smooth = smooth + (adc0 - smooth) / 8
        sv.slow = floor((sv.slow * 7 + adc1) / 8)
        drift = drift * 0.99 + sv.rateZ * 0.01
        if adc2 > high then high = adc2 end
        if low == 0 or adc2 < low then sv.low = adc2 end
        if high > 0 then high = high - 1 end
        sv.high = high
        last = abs(adc0 - adc1)
    end

    local function control()
        local miss, integral, enable = sv.miss, 0, sv.enable
        if enable then integral = min(max(sv.integral + miss * 0.01, -500), 500) end
        local command = miss * 0.5 + integral - drift
        local pwm = cut(command / 8 + 128, 0, 255)
        sv.integral, sv.command, sv.pwm = integral, command, pwm
        sv.duty = floor(pwm * 100 / 255)
        sv.direction = command > 0 and 1 or command < 0 and -1 or 0
        sv.brake = abs(command) < 20 and not enable
    end

    local function judge()
        local adc0, mode, errors = sv.adc0, sv.mode, sv.errors
        local hot, spinning = sv.celsius > 120 or sv.volts1 > 4.5, sv.spin > 500000000
        sv.hot, sv.spinning = hot, spinning
        sv.steady = abs(sv.rateX) < 5 and abs(sv.rateY) < 5 and abs(sv.rateZ) < 5
        if adc0 == 0 or adc0 == 4095 then bad = bad + 1 end
        if bad > 3 then
            errors = min(errors + 1, 65535)
            bad = 0
        end
        local alarm = errors > 100 or hot and spinning
        sv.alarm = alarm
        if mode == 3 and alarm then errors = max(errors - 100, 0) end
        sv.errors = errors
        if last > 3000 and mode ~= 2 then sv.tilt = min(-sv.tilt, 127) end
    end

    local function init()
        for name in ([[volts0 volts1 current power celsius rateX rateY rateZ smooth lift energy kelvin altitude integral command
                density position balance ticks pulses miss product spin total minutes rest turn trimmed mean slow high low errors
                half direction tilt pwm duty level beats]]):gmatch("%w+") do
            sv[name] = 0
        end
        sv.hot, sv.spinning, sv.steady, sv.alarm, sv.brake = false, false, false, false, false
        sv.state = 1
        drift, last, bad, before, first = 0, 0, 0, 0, true
    end

    local function step()
        if first then
            first = false
            sv.state = 1
        end
        units()
        whole()
        counters()
        filters()
        control()
        judge()
    end

    return step, init
end
