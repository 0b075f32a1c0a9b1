# A transducer of 0 to 1250 psi gives 0 to 5 V; a high pin opens the vent.
[analog]
i 0 tankPressure @scale 250
[digital]
o 8 valveOpen @safe true
