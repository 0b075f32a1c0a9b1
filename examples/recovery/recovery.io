# Which pin of an Arduino is what. The altimeter gives 0.5 V on the pad and 1 V more every 100 m. A resistor
# pulls its pin to ground: a broken wire reads -50 m and a short to the supply 450 m, neither of which the machine believes.
# Igniters hang on transistors: a high pin lets the current through, and none must be high before the machine says so.

[analog]
i 0 altitude @scale 100 @offset -50

[digital]
o 8 drogueCharge @safe false
o 9 mainCharge   @safe false
