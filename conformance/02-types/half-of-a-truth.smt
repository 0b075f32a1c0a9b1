spec 2.10   A truth is a number: half of it is between two whole ones, and whole numbers compare with it as such.

-- app.sm --
[state_vector]
U64 G
U32 S
I16 level
bool at_least
bool below
bool equal

[Run]
.step
    at_least = level >= 0.5 * (0 >= 0)
    below = level < 0.5 * (level == level)
    equal = level == 0.5 * (G >= 0)

-- app.ss --
[options]
delta_t 1

[all_states]
G == 5 {
    @assert not at_least
    @assert below
    @assert not equal
    @stop
}
