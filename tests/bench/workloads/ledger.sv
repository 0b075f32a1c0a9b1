# The readings first.

[In]
U64   time        # ns
I32   in0
I32   in1
I32   in2
I32   in3
I32   in4
I32   in5
I32   in6
I32   in7
I32   in8
I32   in9
I32   in10
I32   in11
I32   in12
I32   in13
I32   in14
I32   in15
bool  clear

[Out]
U32   state
I64   position
I64   worst
U64   distance
U64   age
U64   checks
U32   late
I32   mean
bool  full
