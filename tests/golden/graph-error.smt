# A machine with an error has no diagram.
args graph a.sm -o a.svg; ls

-- a.sm --
[state_vector]
U64 G
U32 S
[Idle]
.step
    T > 5: -> Nowhere
-- stdout --
a.sm
-- stderr --
a.sm:6:15: error: unknown state 'Nowhere' [E0501]
    6 |     T > 5: -> Nowhere
      |               ^~~~~~~ add a section [Nowhere]
1 error
