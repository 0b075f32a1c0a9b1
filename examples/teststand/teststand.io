# How the stand is wired. Pressure sensors give 0.5 V at 0 bar and 4.5 V at full scale, so that a broken wire reads below zero; the
# amplifier of the thermocouple gives 5 mV/K and 1.25 V at 0 degrees Celsius; the flow meter 0.5 V at rest and 4.5 V at 2 kg/s.

[analog]
i 0  chamberPressureA  @scale 15   @offset -7.5
i 1  chamberPressureB  @scale 15   @offset -7.5
i 2  tankPressure      @scale 15   @offset -7.5
i 3  lineTemperature   @scale 200  @offset 23.15
i 4  flow              @scale 0.5  @offset -0.25

[digital]
i 0  key               @pull_down
i 1  flame             @pull_down
o 8  igniter           @safe false
o 9  oxidizerValve     @safe false
o 10 fuelValve         @safe false
o 11 chillValve        @safe false
o 12 purgeValve        @safe false
# Without current the vent is open: a stand without control loses its pressure.
o 13 ventValve         @inverted @safe true
