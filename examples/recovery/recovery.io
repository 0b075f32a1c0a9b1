# Which pin of an Arduino is what. The altimeter gives 0.5 V on the pad and 1 V more every 100 m. A resistor
# pulls its pin to ground: a broken wire reads -50 m and a short to the supply 450 m, neither of which the machine believes.
# Transistors switch the igniters: a high pin lets the current through, so no pin may be high before the machine sets it.

[analog]
i 0 altitude @scale 100 @offset -50

[digital]
o 8 drogueCharge @safe false
o 9 mainCharge   @safe false
