spec 5.18  Two states of one name are an error.

-- app.sm --
[state_vector]
U64 G
U32 S

[A]
[B]
[A]   #! E0502
