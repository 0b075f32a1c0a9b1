spec 5.45   A state has only annotations of states, each once.

-- app.sm --
[state_vector]
U64 G
U32 S
bool open
[A] @read_only            #! E0376 '@read_only' marks a variable, not a state
.step
    open = true
[B] @alias                #! E0376 '@alias'
.step
    -> A
[C] @safe @abort
    @safe                 #! E0361 duplicate '@safe' on 'C'
[D] @save                 #! E0360 did you mean '@safe'?
[E] @abort x = 1          #! E0310
[F] @Abort                #! E0360 did you mean '@abort'?
