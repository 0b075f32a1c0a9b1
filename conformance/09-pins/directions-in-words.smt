spec 9.2   Directions in other words, and what they are here.

-- app.sv --
[Sensors]
bool e0
bool e1
bool e2
bool e3
bool e4
bool e5
bool e6
bool e7
bool e8
bool e9
bool e10
bool e11
bool e12
bool e13
bool e14
bool e15
bool e16
bool e17
bool e18
bool e19
bool e20
bool e21
-- app.io --
[digital]
in 0 e0                       #! E1172 did you mean 'i'?
input 1 e1                    #! E1172 did you mean 'i'?
inputs 2 e2                   #! E1172 did you mean 'i'?
I 3 e3                        #! E1172 did you mean 'i'?
IN 4 e4                       #! E1172 did you mean 'i'?
ai 5 e5                       #! E1172 did you mean 'i'?
di 6 e6                       #! E1172 did you mean 'i'?
AI 7 e7                       #! E1172 did you mean 'i'?
DI 8 e8                       #! E1172 did you mean 'i'?
read 9 e9                     #! E1172 did you mean 'i'?
sensor 10 e10                 #! E1172 did you mean 'i'?
out 11 e11 @safe false        #! E1172 did you mean 'o'?
output 12 e12 @safe false     #! E1172 did you mean 'o'?
outputs 13 e13 @safe false    #! E1172 did you mean 'o'?
O 14 e14 @safe false          #! E1172 did you mean 'o'?
OUT 15 e15 @safe false        #! E1172 did you mean 'o'?
ao 16 e16 @safe false         #! E1172 did you mean 'o'?
do 17 e17 @safe false         #! E1172 did you mean 'o'?
AO 18 e18 @safe false         #! E1172 did you mean 'o'?
DO 19 e19 @safe false         #! E1172 did you mean 'o'?
write 20 e20 @safe false      #! E1172 did you mean 'o'?
actuator 21 e21 @safe false   #! E1172 did you mean 'o'?
