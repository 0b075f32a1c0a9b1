-- SPDX-License-Identifier: Apache-2.0
-- The glider in Lua: each sine and cosine once.  atan2 is a function of its own in Lua 5.1, and math.atan with two arguments later.
local sin, cos, asin, atan, sqrt, exp, log, floor, abs, pi = math.sin, math.cos, math.asin, math.atan, math.sqrt, math.exp, math.log, math.floor, math.abs, math.pi
local atan2 = math.atan2 or math.atan
local dt, earth = 0.02, 6371000

local function wrapped(angle) return angle - 2 * pi * floor((angle + pi) / (2 * pi)) end

-- Without the fraction, as an integer has none.
local function whole(x) return x < 0 and -floor(-x) or floor(x) end

return function(sv)
    local number, first, start, roll, pitch, yaw, lat, lon

    local function init()
        for name in ("roll pitch yaw lat lon track bearing distance bank density rudder rounds"):gmatch("%w+") do sv[name] = 0 end
        sv.state, sv.flare = 1, false
        number, first, start, roll, pitch, yaw, lat, lon = 1, true, 0, 0, 0, 0, 0, 0
    end

    local function attitude()
        local q, r, sr, cr, secant = sv.gyroQ, sv.gyroR, sin(roll), cos(roll), 1 / cos(pitch)
        local h = q * sr + r * cr
        roll = 0.99 * (roll + dt * (sv.gyroP + h * sin(pitch) * secant))
        yaw = wrapped(yaw + dt * h * secant)
        pitch = 0.99 * (pitch + dt * (q * cr - r * sr))
        sv.roll, sv.pitch, sv.yaw = roll, pitch, yaw
    end

    -- Returns the speed over ground, the distance, and the error of the direction.
    local function navigate()
        local level, padLat, padLon = sv.airspeed * cos(pitch), sv.padLat, sv.padLon
        local north, east = level * cos(yaw) + sv.windNorth, level * sin(yaw) + sv.windEast
        local cosPad, track = cos(padLat), atan2(east, north)
        lat = lat + dt / earth * north
        local cosLat = cos(lat)
        lon = lon + dt / earth * east / cosLat
        local wide = padLon - lon
        local halfLat, halfLon = sin((padLat - lat) / 2), sin(wide / 2)
        local root = sqrt(halfLat * halfLat + cosLat * cosPad * halfLon * halfLon)
        local distance = 2 * earth * asin(root < 1 and root or 1)
        local bearing = atan2(sin(wide) * cosPad, cosLat * sin(padLat) - sin(lat) * cosPad * (1 - 2 * halfLon * halfLon))
        sv.lat, sv.lon, sv.track, sv.distance, sv.bearing, sv.density = lat, lon, track, distance, bearing, 1.225 * exp(-distance / 8400)
        return sqrt(north * north + east * east), distance, wrapped(bearing - track)
    end

    local function steer(speed, distance, error)
        local T = sv.time - start
        if number == 1 then
            local bank = atan2(speed * error * 0.3, 9.81)
            sv.bank = bank < -0.8 and -0.8 or bank > 0.8 and 0.8 or bank
            sv.rudder = whole(error * 2000)
            if distance < 400 then number, first = 2, true end
        elseif number == 2 then
            local airspeed = sv.airspeed
            sv.bank = atan(airspeed * airspeed / (9.81 * (distance > 50 and distance or 50)))
            sv.rudder = whole(3000 * sin(error) - 500 * sin(2 * error))
            if distance > 600 then
                number, first = 1, true
            elseif T > 4000 and abs(error) < 0.3 then
                number, first = 3, true
            end
        else
            sv.bank = 0.1 * log(1 + distance) * (error < 0 and -1 or 1)
            sv.rudder = 0
            if T > 2000 then number, first = 1, true end
        end
    end

    local function step()
        if first then
            first = false
            start = sv.time
            sv.state = number
            if number == 2 then sv.rounds = sv.rounds + 1 else sv.flare = number == 3 end
        end
        attitude()
        steer(navigate())
    end

    return step, init
end
