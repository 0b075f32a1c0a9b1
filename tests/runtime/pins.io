[analog]
i 0 pressure @scale 250 @offset -125 @hold 2
i 1 flow @scale -0.1
i 2 small @scale 1000
i 3 count @scale 1e3 @hold 255
i 4 wide @scale 1e19
o 5 heater @scale 4 @offset 2 @safe 10
o 6 fan @scale 100 @safe 50
o 7 heater

[digital]
i 10 limit @pull_up @inverted @hold 1
i 11 door @pull_up
i 12 float
o 20 valve @safe true
o 21 vent @inverted
o 22 valve @inverted @safe true
