-- SPDX-License-Identifier: Apache-2.0
-- The decisions in Lua.
local function up(x)
    return x < 255 and x + 1 or x
end

local function cut(x)
    if x < -32768 then return -32768 end
    return x
end

return function(sv)
    local first

    local function init()
        sv.state, sv.valve, sv.trim, sv.code, sv.level, sv.warnings, sv.vote = 1, 0, 0, 0, 0, 0, 0
        sv.open, sv.spark, sv.alarm = false, false, false
        first = true
    end

    local function step()
        local chamber, lox, fuel, flow, thrust, bus, speed, vibe, temp, mode, command, armed, hot, cold, wet =
            sv.chamber, sv.lox, sv.fuel, sv.flow, sv.thrust, sv.bus, sv.speed, sv.vibe,
            sv.temp, sv.mode, sv.command, sv.armed, sv.hot, sv.cold, sv.wet
        if first then
            first = false
            sv.state = 1
        end
        if (not cold and speed < 9000) then
            if temp > -100 then
                if hot then
                    if armed then
                        if command < 128 then
                            if fuel >= 20 then
                                if flow >= 2 then
                                    sv.valve = flow / 3
                                else
                                    sv.level = up(sv.level)
                                end
                            end
                            if hot then
                                if cold then
                                    if (thrust > 4000 or mode > 2) then
                                        if cold then
                                            sv.warnings = up(sv.warnings)
                                        end
                                    end
                                else
                                    sv.valve = flow / 6
                                    sv.level = up(sv.level)
                                end
                            end
                        end
                    else
                        sv.open = hot or armed
                        if (temp >= -100 or lox >= 30) then
                            if not hot then
                                if vibe > 50 then
                                    sv.code = 7
                                else
                                    sv.valve = flow / 3
                                end
                            end
                        else
                            sv.vote = -41
                        end
                    end
                end
            end
            if vibe > 200 then
                if fuel > 10 then
                    if fuel >= 40 then
                        if armed then
                            if (lox >= 20 or temp >= 100) then
                                if hot then
                                    if wet then
                                        if hot then
                                            if command > 128 then
                                                if chamber > 20 then
                                                    if speed > 15000 then
                                                        if (fuel < 40 or vibe >= 50) then
                                                            sv.open = hot or armed
                                                            sv.vote = -39
                                                        end
                                                    else
                                                        sv.code = 12
                                                        sv.vote = -37
                                                    end
                                                else
                                                    if armed then
                                                        sv.valve = flow / 2
                                                        sv.level = up(sv.level)
                                                    else
                                                        sv.vote = -34
                                                    end
                                                    if cold then
                                                        sv.open = hot or armed
                                                    end
                                                end
                                                sv.valve = flow / 6
                                            else
                                                if bus < 27000 then
                                                    sv.open = hot or armed
                                                    if hot then
                                                        if armed then
                                                            sv.open = hot or armed
                                                        else
                                                            sv.trim = cut(vibe - 21)
                                                            sv.vote = -28
                                                        end
                                                        if thrust >= 2000 then
                                                            sv.level = up(sv.level)
                                                        else
                                                            sv.level = up(sv.level)
                                                            sv.warnings = up(sv.warnings)
                                                        end
                                                    end
                                                end
                                            end
                                        end
                                    else
                                        sv.warnings = up(sv.warnings)
                                        sv.vote = -23
                                    end
                                end
                                sv.valve = flow / 2
                            else
                                sv.trim = cut(vibe - 29)
                                sv.level = up(sv.level)
                            end
                        end
                    else
                        sv.open = hot or armed
                    end
                else
                    sv.level = up(sv.level)
                    sv.vote = -17
                end
            end
        else
            if mode > 3 then
                if thrust > 8000 then
                    if chamber < 50 then
                        if not hot then
                            if cold then
                                if lox > 10 then
                                    sv.warnings = up(sv.warnings)
                                else
                                    sv.code = 35
                                    sv.code = 36
                                end
                            else
                                if temp > 250 then
                                    if wet then
                                        sv.open = hot or armed
                                    else
                                        sv.warnings = up(sv.warnings)
                                        sv.level = up(sv.level)
                                    end
                                    sv.trim = cut(vibe - 40)
                                end
                            end
                        else
                            if bus < 27000 then
                                if bus < 25000 then
                                    if vibe >= 200 then
                                        if (command < 128 or speed < 15000) then
                                            if (flow < 6 and armed) then
                                                if bus > 23000 then
                                                    if mode > 3 then
                                                        sv.warnings = up(sv.warnings)
                                                    end
                                                    sv.valve = flow / 2
                                                else
                                                    sv.vote = -7
                                                    sv.valve = flow / 4
                                                end
                                                sv.trim = cut(vibe - 45)
                                            else
                                                sv.vote = -4
                                                sv.level = up(sv.level)
                                            end
                                            if vibe >= 200 then
                                                if (command >= 128 or lox >= 20) then
                                                    sv.open = hot or armed
                                                else
                                                    sv.level = up(sv.level)
                                                end
                                            end
                                        end
                                        if not wet then
                                            if flow < 2 then
                                                if speed < 15000 then
                                                    sv.code = 50
                                                else
                                                    if bus > 21000 then
                                                        if mode > 2 then
                                                            sv.warnings = up(sv.warnings)
                                                        else
                                                            sv.trim = cut(vibe - 52)
                                                        end
                                                    else
                                                        sv.code = 53
                                                        sv.valve = flow / 7
                                                    end
                                                    if thrust > 8000 then
                                                        if (chamber < 65 or speed < 15000) then
                                                            sv.code = 55
                                                        end
                                                        sv.valve = flow / 2
                                                    end
                                                end
                                            end
                                        else
                                            if temp >= 0 then
                                                sv.trim = cut(vibe - 57)
                                            end
                                        end
                                    else
                                        sv.valve = flow / 4
                                    end
                                    if (cold or hot) then
                                        if wet then
                                            if (fuel > 10 or not hot) then
                                                sv.vote = 9
                                                if command < 64 then
                                                    if hot then
                                                        if speed < 9000 then
                                                            sv.level = up(sv.level)
                                                        else
                                                            sv.level = up(sv.level)
                                                        end
                                                        sv.level = up(sv.level)
                                                    end
                                                    if command < 64 then
                                                        if mode > 3 then
                                                            sv.trim = cut(vibe - 63)
                                                            sv.trim = cut(vibe - 64)
                                                        end
                                                    else
                                                        sv.level = up(sv.level)
                                                    end
                                                end
                                            else
                                                sv.code = 66
                                            end
                                        else
                                            if lox >= 10 then
                                                if not cold then
                                                    if chamber < 50 then
                                                        if speed >= 9000 then
                                                            sv.vote = 17
                                                        else
                                                            sv.open = hot or armed
                                                        end
                                                        if command > 32 then
                                                            sv.warnings = up(sv.warnings)
                                                            sv.trim = cut(vibe - 70)
                                                        end
                                                    end
                                                    if lox >= 50 then
                                                        if cold then
                                                            sv.warnings = up(sv.warnings)
                                                            sv.valve = flow / 4
                                                        else
                                                            sv.level = up(sv.level)
                                                        end
                                                    else
                                                        sv.trim = cut(vibe - 74)
                                                    end
                                                end
                                                if (mode == 3 and chamber > 20) then
                                                    if (wet and speed >= 15000) then
                                                        if (bus > 27000 or armed) then
                                                            sv.trim = cut(vibe - 75)
                                                        end
                                                    end
                                                    sv.code = 76
                                                end
                                            else
                                                sv.trim = cut(vibe - 77)
                                            end
                                            sv.valve = flow / 3
                                        end
                                    end
                                else
                                    if (hot and vibe < -50) then
                                        sv.level = up(sv.level)
                                    end
                                end
                            end
                        end
                        if (lox > 40 and cold) then
                            if thrust < 6000 then
                                sv.vote = 30
                                if wet then
                                    if (lox < 10 and command < 128) then
                                        if command >= 64 then
                                            if bus > 25000 then
                                                if fuel < 20 then
                                                    if flow < 2 then
                                                        if chamber > 50 then
                                                            sv.level = up(sv.level)
                                                        end
                                                    else
                                                        sv.open = hot or armed
                                                        if thrust >= 2000 then
                                                            sv.vote = 33
                                                            sv.vote = 34
                                                        else
                                                            sv.warnings = up(sv.warnings)
                                                            sv.code = 86
                                                        end
                                                    end
                                                    if mode > 1 then
                                                        sv.valve = flow / 5
                                                    else
                                                        sv.level = up(sv.level)
                                                        sv.code = 89
                                                    end
                                                end
                                            end
                                            if mode ~= 3 then
                                                if (command > 128 or not wet) then
                                                    if (vibe >= 200 and lox > 30) then
                                                        if (lox >= 40 and wet) then
                                                            sv.trim = cut(vibe - 90)
                                                        else
                                                            sv.open = hot or armed
                                                        end
                                                    else
                                                        if (temp >= 100 or hot) then
                                                            sv.level = up(sv.level)
                                                        else
                                                            sv.vote = 43
                                                            sv.warnings = up(sv.warnings)
                                                        end
                                                    end
                                                end
                                            end
                                        else
                                            if vibe >= -50 then
                                                if (chamber >= 80 and not armed) then
                                                    sv.vote = 45
                                                    if vibe < 200 then
                                                        sv.trim = cut(vibe - 96)
                                                    else
                                                        sv.valve = flow / 8
                                                        sv.vote = 48
                                                    end
                                                else
                                                    if speed >= 12000 then
                                                        if thrust >= 8000 then
                                                            sv.warnings = up(sv.warnings)
                                                        else
                                                            sv.open = hot or armed
                                                        end
                                                        sv.code = 101
                                                    else
                                                        sv.trim = cut(vibe - 102)
                                                    end
                                                end
                                            else
                                                sv.valve = flow / 7
                                                sv.warnings = up(sv.warnings)
                                            end
                                        end
                                        if thrust < 8000 then
                                            if flow > 4 then
                                                if armed then
                                                    if lox < 50 then
                                                        if flow > 6 then
                                                            sv.code = 105
                                                            sv.warnings = up(sv.warnings)
                                                        else
                                                            sv.trim = cut(vibe - 107)
                                                        end
                                                    end
                                                    if chamber > 80 then
                                                        sv.vote = -42
                                                    end
                                                else
                                                    sv.open = hot or armed
                                                end
                                            end
                                            if (thrust >= 2000 or mode == 2) then
                                                if (fuel >= 50 or mode == 3) then
                                                    if bus < 23000 then
                                                        sv.vote = -40
                                                    else
                                                        sv.trim = cut(vibe - 111)
                                                        sv.vote = -38
                                                    end
                                                    if lox >= 20 then
                                                        if (cold and vibe < 50) then
                                                            sv.valve = flow / 3
                                                        else
                                                            sv.valve = flow / 4
                                                        end
                                                    else
                                                        if not cold then
                                                            sv.warnings = up(sv.warnings)
                                                            sv.code = 116
                                                        else
                                                            sv.warnings = up(sv.warnings)
                                                        end
                                                        if mode ~= 3 then
                                                            sv.code = 118
                                                        end
                                                    end
                                                end
                                            else
                                                if (thrust >= 2000 and wet) then
                                                    if lox < 40 then
                                                        if hot then
                                                            sv.vote = -31
                                                        end
                                                    else
                                                        if bus < 27000 then
                                                            sv.code = 120
                                                        else
                                                            sv.warnings = up(sv.warnings)
                                                            sv.open = hot or armed
                                                        end
                                                    end
                                                end
                                            end
                                        end
                                    else
                                        sv.trim = cut(vibe - 123)
                                        sv.open = hot or armed
                                    end
                                else
                                    sv.open = hot or armed
                                end
                            else
                                sv.warnings = up(sv.warnings)
                                sv.code = 127
                            end
                        else
                            sv.level = up(sv.level)
                        end
                    else
                        sv.valve = flow / 5
                    end
                else
                    sv.code = 130
                end
            else
                if chamber < 80 then
                    if flow > 8 then
                        sv.trim = cut(vibe - 131)
                    end
                end
            end
        end
        local level, warnings = sv.level, sv.warnings
        sv.spark = sv.code > 65 and level > 20
        sv.alarm = warnings > 100 or sv.vote < -40
        if level > 200 then sv.level = 0 end
        if warnings > 200 then sv.warnings = 0 end
    end

    return step, init
end
