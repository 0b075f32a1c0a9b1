# What is printed beside the pins of an Arduino is more than their number: said is which to write.
args check a.io --sv a.sv

-- a.sv --
[A]
U64 time
F64 x
bool b
-- a.io --
[analog]
i A0 x
o D3 x
o A1 x
i A123 x
[digital]
i A5 b
i a15 b
o D13 b
-- stderr --
a.io:2:3: error: expected a pin, a whole number from 0 to 65535, found 'A0' [E1173]
    2 | i A0 x
      |   ^~ write 0 for the A0 of an Arduino
a.io:3:3: error: expected a pin, a whole number from 0 to 65535, found 'D3' [E1173]
    3 | o D3 x
      |   ^~ write 3 for the D3 of an Arduino
a.io:4:3: error: expected a pin, a whole number from 0 to 65535, found 'A1' [E1173]
    4 | o A1 x
      |   ^~
a.io:5:3: error: expected a pin, a whole number from 0 to 65535, found 'A123' [E1173]
    5 | i A123 x
      |   ^~~~
a.io:7:3: error: expected a pin, a whole number from 0 to 65535, found 'A5' [E1173]
    7 | i A5 b
      |   ^~ write 19 for that pin of an Arduino Uno, 59 for that of a Mega
a.io:8:3: error: expected a pin, a whole number from 0 to 65535, found 'a15' [E1173]
    8 | i a15 b
      |   ^~~ write 69 for the a15 of an Arduino
a.io:9:3: error: expected a pin, a whole number from 0 to 65535, found 'D13' [E1173]
    9 | o D13 b
      |   ^~~ write 13 for the D13 of an Arduino
7 errors
-- exit --
1
