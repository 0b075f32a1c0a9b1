-- SPDX-License-Identifier: Apache-2.0
-- The Kalman filter in Lua: estimates and covariances in upvalues.
local abs, sqrt = math.abs, math.sqrt

return function(sv)
    local noise = {1, 400, 25, 100}
    local number, first, start, last, misses, q, p00, p01, p02, p11, p12, p22, height, speed, bias

    local function init()
        sv.state, sv.height, sv.speed, sv.bias, sv.sigma, sv.nis, sv.rejected, sv.drogue = 1, 0, 0, 0, 0, 0, 0, false
        number, first, start, last, misses = 1, true, 0, 0, 0
        p00, p01, p02, p11, p12, p22 = 100, 0, 0, 10, 0, 1
        height, speed, bias = 0, 0, 0
    end

    local function update(y, s)
        if s == 0 then return end
        local k0, k1, k2 = p00 / s, p01 / s, p02 / s
        height = height + k0 * y
        speed = speed + k1 * y
        bias = bias + k2 * y
        p22 = p22 - k2 * p02
        p12 = p12 - k1 * p02
        p11 = p11 - k1 * p01
        p02 = (1 - k0) * p02
        p01 = (1 - k0) * p01
        p00 = (1 - k0) * p00
    end

    local function predict(a, dt)
        local e = dt * dt / 2
        height = height + speed * dt + a * e
        speed = speed + a * dt
        local a01 = p01 + dt * p11 - e * p12
        local a02 = p02 + dt * p12 - e * p22
        local a12 = p12 - dt * p22
        p00 = p00 + dt * p01 - e * p02 + dt * a01 - e * a02 + q * e * e
        p01 = a01 - dt * a02 + q * e * dt
        p02 = a02
        p11 = p11 - dt * p12 - dt * a12 + q * dt * dt
        p12 = a12
        p22 = p22 + 0.0001 * dt
    end

    local function measure()
        local y, s = sv.baro - height, p00 + sv.baroVar
        local d = (s ~= 0 or y ~= 0) and y * y / s or 0
        sv.nis = d < 100 and d or 100
        if d < 16 or misses > 20 then
            misses = 0
            update(y, s)
        else
            misses = misses + 1
            if sv.rejected < 65535 then sv.rejected = sv.rejected + 1 end
        end
        if sv.fix then update(sv.gps - height, p00 + sv.gpsVar) end
        sv.height, sv.speed, sv.bias, sv.sigma = height, speed, bias, sqrt(p00)
    end

    local function step()
        local time = sv.time
        if first then
            first = false
            start = time
            sv.state, q = number, noise[number]
            if number == 1 then sv.drogue = false elseif number == 4 then sv.drogue = true end
        end
        local a = sv.accel - bias
        predict(a, (time - last) / 1000)
        last = time
        measure()
        local done
        if number == 1 then
            done = a > 20 and speed > 5
        elseif number == 2 then
            done = a < 0 and time - start > 500
        elseif number == 3 then
            done = speed + 2 * sqrt(p11) < 0
        else
            done = abs(speed) < 3 and height < 30 and time - start > 2000
        end
        if done then number, first = number % 4 + 1, true end
    end

    return step, init
end
