-- SPDX-License-Identifier: Apache-2.0
-- Runs a workload in Lua 5.1 and later, LuaJIT too:  driver.lua WORKLOAD INPUTS
-- INPUTS: numbers of inputs, outputs, episodes, steps, warm steps; names and types of inputs; names of outputs; the inputs.
-- Commands on standard input, one a line, each with an answer of one line:
--     run E               seconds of processor time that the measured steps of episode E took
--     check E STEPS FILE  writes the outputs of the first steps to FILE
--     count E STEPS       runs the warm steps and so many more
local folder = arg[0]:match("^(.*)/") or "."
local make = dofile(folder .. "/workloads/" .. arg[1] .. ".lua")
local load = loadstring or load

local f = assert(io.open(arg[2]))
local inputs, outputs, episodes, steps, warm = f:read("*n", "*n", "*n", "*n", "*n")
f:read("*l")

local function words(line)
    local list = {}
    for word in line:gmatch("%S+") do list[#list + 1] = word end
    return list
end

local name, kind, output = words(f:read("*l")), words(f:read("*l")), words(f:read("*l"))
local column = {}
for k = 1, inputs do column[k] = {} end
for i = 1, episodes * steps do
    for k = 1, inputs do
        local x = f:read("*n")
        if kind[k] == "bool" then x = x ~= 0 end
        column[k][i] = x
    end
end
f:close()

-- The loop that gives the machine its inputs, as one would write it for this workload.
local lines = {"local sv, column = ...\n"}
for k = 1, inputs do lines[#lines + 1] = ("local c%d = column[%d]\n"):format(k, k) end
lines[#lines + 1] = "return function(step, from, to)\nfor i = from, to do\n"
for k = 1, inputs do lines[#lines + 1] = ("sv.%s = c%d[i]\n"):format(name[k], k) end
lines[#lines + 1] = "step()\nend\nend\n"

local sv = {}
local step, init = make(sv)
local drive = assert(load(table.concat(lines)))(sv, column)

local clock = os.clock
local command = {}

function command.run(e)
    local first = e * steps
    init()
    drive(step, first + 1, first + warm)
    local before = clock()
    drive(step, first + warm + 1, first + steps)
    return ("%.9f"):format(clock() - before)
end

function command.count(e, n)
    local first = e * steps
    init()
    drive(step, first + 1, first + warm)
    drive(step, first + warm + 1, first + warm + n)
    return "done"
end

function command.check(e, n, path)
    local out = assert(io.open(path, "w"))
    init()
    for i = 1, n do
        drive(step, e * steps + i, e * steps + i)
        for k = 1, outputs do
            local x = sv[output[k]]
            if x == true then x = 1 elseif not x then x = 0 end
            out:write(("%.17g "):format(x))
        end
        out:write("\n")
    end
    out:close()
    return "done"
end

for line in io.lines() do
    local w = words(line)
    io.write(command[w[1]](tonumber(w[2]), tonumber(w[3]), w[4]), "\n")
    io.flush()
end
