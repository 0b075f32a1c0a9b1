spec 8.32  @fail needs a text.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x
bool open
[Hold]
.step
    open = x > 5
    x == 100: -> Vent
[Vent]
.step
    open = false
-- app.ss --
[options]
delta_t 10
[all_states]
G == 0: @fail             #! E0346
G == 5: @fail ""          #! E0346 found an empty text
G == 5: @fail "" @req R1  #! E0346
G == 10: @stop
