# Which pin of an Arduino is what. The altimeter gives 0.5 V on the pad and 1 V more every 100 m.
# Igniters hang on transistors: a high pin lets the current through, and none must be high before the machine says so.

[analog]
i 0 altitude @scale 100 @offset -50

[digital]
o 8 drogueCharge @safe false
o 9 mainCharge   @safe false
