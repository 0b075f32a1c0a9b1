spec 11.10 11.17  Ages and counts are whole numbers.

-- app.sv --
[Tank]
F64  tankPressure
bool valveOpen
[Commands]
bool ventCommand
F32  throttle
I16  small
U32  age
U32  bad
U16  other
-- app.net --
receive a on 5001 @age throttle { small }                  #! E1033 an age is of an integer type
receive b on 5002 @count refsed bad { ventCommand }        #! E1216 did you mean
receive c on 5003 @count sent bad { age }                  #! E1216
receive d on 5004 @count late other @count late bad { tankPressure }     #! E0361
