spec 8.1, 8.3, 8.7   Words that scripts elsewhere have are answered with those of this language.
-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
[Hold]
-- app.ss --
[options]
delta_t 10
dt 10                      #! E0371 delta_t
[all]                      #! E0501 [all_states]
G == 0: x = 1
G == 20: @stop
