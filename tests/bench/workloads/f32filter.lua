-- SPDX-License-Identifier: Apache-2.0
-- The filters in Lua.
local abs = math.abs

local function limit(x, least, most)
    if x < least then return least end
    if x > most then return most end
    return x
end

return function(sv)
    local xa, xb, ya, yb, ua, ub, va, vb, lastWash, lastBand, slowBand, lastLead, first

    local function init()
        for name in ("smoothX smoothY smoothZ notchX notchY pitch roll height climb slewed error integral output energy peak washed band lead"):gmatch("%w+") do
            sv[name] = 0
        end
        sv.state, sv.moving, sv.saturated = 1, false, false
        xa, xb, ya, yb, ua, ub = 0, 0, 0, 0, 0, 0
        va, vb, lastWash, lastBand, slowBand, lastLead = 0, 0, 0, 0, 0, 0
        first = true
    end

    local function step()
        local accX, accY, accZ, gyroX, baro = sv.accX, sv.accY, sv.accZ, sv.gyroX, sv.baro
        local smoothX, smoothY, smoothZ = sv.smoothX, sv.smoothY, sv.smoothZ
        if first then
            first = false
            sv.state = 1
        end
        smoothX = smoothX + (accX - smoothX) * 0.125
        smoothY = smoothY + (accY - smoothY) * 0.125
        smoothZ = smoothZ + (accZ - smoothZ) * 0.125
        sv.smoothX, sv.smoothY, sv.smoothZ = smoothX, smoothY, smoothZ
        local notchX = 0.90 * (accX + xb) - 1.55 * (xa - ya) - 0.80 * yb
        xb, xa, yb, ya = xa, accX, ya, notchX
        local notchY = 0.85 * (accY + ub) - 1.20 * (ua - va) - 0.70 * vb
        ub, ua, vb, va = ua, accY, va, notchY
        sv.notchX, sv.notchY = notchX, notchY
        local pitch = 0.98 * (sv.pitch + gyroX * 0.01) + 0.02 * smoothX
        sv.pitch = pitch
        sv.roll = 0.98 * (sv.roll + sv.gyroY * 0.01) + 0.02 * smoothY
        local height = sv.height
        local error = baro - height
        local climb = limit((sv.climb + (smoothZ * 0.01 + error * 0.02)) * 0.999, -300, 300)
        sv.error, sv.climb, sv.height = error, climb, height + climb * 0.01 + error * 0.1
        local slewed = sv.slewed
        slewed = slewed + limit(sv.command - slewed, -0.5, 0.5)
        sv.slewed = slewed
        sv.washed = 0.95 * (sv.washed + smoothX - lastWash)
        lastWash = smoothX
        local band = 0.9 * (sv.band + baro - lastBand)
        lastBand = baro
        sv.band = band
        slowBand = slowBand + (abs(band) - slowBand) * 0.01
        sv.lead = smoothY + (smoothY - lastLead) * 4
        lastLead = smoothY
        local integral = limit(sv.integral + (slewed - pitch) * 0.01, -2, 2)
        local output = limit((slewed - pitch) * 1.5 + integral - gyroX * 0.2, -1, 1)
        sv.integral, sv.output = integral, output
        local energy = sv.energy * 0.99 + (accX * accX + accY * accY + accZ * accZ) * 0.01
        sv.energy = energy
        local peak, size = sv.peak * 0.995, abs(notchX) + abs(notchY)
        sv.peak = size > peak and size or peak
        sv.moving = energy > 30 or slowBand > 2
        sv.saturated = output == 1 or output == -1
    end

    return step, init
end
