# The note says where and when the value is overwritten: in the same step, in the next one, or in a later state.
args check a.sm

-- a.sm --
[state_vector]
U64 G
U32 S
F64 altitude @read_only
F64 speed
[local]
F64 low = 0
F64 mean = 0
F64 high = 0
F64 turn = 0
F64 own = 0
[Drogue]
.entry
    high = altitude
    own = 2
.step
    low = altitude
    speed = 1
    speed = 2
    mean = altitude
    altitude < 300 {
        mean = 3
        low = 1
        turn = 7
        -> Main
    }
    low = 5
    turn = 5
    altitude < 400: speed = turn
    speed > 1 and mean > altitude + own: -> Other
.exit
    high = 4
[Main]
.entry
    low = altitude
    turn = 6
    high = 1
.step
    mean = altitude
    own = altitude
    altitude < mean + low + high + turn: -> Drogue
[Other]
.entry
    mean = 5
    own = 3
    altitude < mean: -> Main
-- stderr --
a.sm:14:5: warning: the value assigned to 'high' is overwritten before it is read [W0410 dead-store]
   14 |     high = altitude
      |     ^~~~~~~~~~~~~~~
a.sm:32:5: note: it is overwritten here
a.sm:17:5: warning: the value assigned to 'low' is overwritten before it is read [W0410 dead-store]
   17 |     low = altitude
      |     ^~~~~~~~~~~~~~
a.sm:23:9: note: it is overwritten here
a.sm:18:5: warning: the value assigned to 'speed' is overwritten before it is read [W0410 dead-store]
   18 |     speed = 1
      |     ^~~~~~~~~
a.sm:19:5: note: it is overwritten here
a.sm:22:9: warning: the value assigned to 'mean' is overwritten before it is read [W0410 dead-store]
   22 |         mean = 3
      |         ^~~~~~~~
a.sm:39:5: note: it is overwritten here when the machine is in 'Main'
a.sm:23:9: warning: the value assigned to 'low' is overwritten before it is read [W0410 dead-store]
   23 |         low = 1
      |         ^~~~~~~
a.sm:35:5: note: it is overwritten here when the machine is in 'Main'
a.sm:24:9: warning: the value assigned to 'turn' is overwritten before it is read [W0410 dead-store]
   24 |         turn = 7
      |         ^~~~~~~~
a.sm:36:5: note: it is overwritten here when the machine is in 'Main'
a.sm:27:5: warning: the value assigned to 'low' is overwritten before it is read [W0410 dead-store]
   27 |     low = 5
      |     ^~~~~~~
a.sm:17:5: note: it is overwritten here in the next step
a.sm:32:5: warning: the value assigned to 'high' is overwritten before it is read [W0410 dead-store]
   32 |     high = 4
      |     ^~~~~~~~
a.sm:37:5: note: it is overwritten here when the machine is in 'Main'
a.sm:40:5: warning: the value assigned to 'own' is overwritten before it is read [W0410 dead-store]
   40 |     own = altitude
      |     ^~~~~~~~~~~~~~
note: the same assignment overwrites it the next time
a.sm:45:5: warning: the value assigned to 'own' is overwritten before it is read [W0410 dead-store]
   45 |     own = 3
      |     ^~~~~~~
a.sm:40:5: note: it is overwritten here when the machine is in 'Main'
10 warnings
