# All kinds of pins of an Uno: as they are, scaled, shifted, turned over, out of their types' ranges, -0 on the way.
[analog]
i 0 plain
i 1 pressure  @scale 311.2873  @offset -125.5
i 2 level     @scale -0.1
i 4 below     @scale -7e3  @offset 0.25
i 5 wide      @scale 1e300 @offset 1
o 3 volts
o 9 valve     @scale 0.2  @offset -0.5  @safe -0.5
o 10 heater   @scale -100 @offset 500  @safe 500
o 11 fan      @scale 51
[digital]
i 2 high
i 4 low       @inverted
i 12 pulled   @pull_up @inverted
o 5 lamp
o 6 dark      @inverted @safe true
o 7 lamp
o 8 twin
