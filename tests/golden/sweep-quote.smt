# CSV of smc sweep: a quotation mark in the name of a script is doubled.
args sweep v.sm 'quote".ss' --set on=false:true:2 --set wait=0:3:2 --format=csv

-- v.sm --
[options]
step 10 ms
[state_vector]
U64 G
U32 S
F64 p @read_only @range 0 1000
bool open
[local]
F64 limit = 775 @parameter @range 500 1000
U32 wait = 50 @parameter @range 0 500
bool on = true @parameter
[Fill]
.step
    open = p > limit and on
    p > 825 and T > wait: -> Abort
[Abort] @abort @safe
.entry
    open = true
-- quote".ss --
[all_states]
true: p = G
at 820: @assert open
at 900: @stop
-- stdout --
wait,on,now,failing,requirements,checks
0,false,,1,0,"quote"".ss:3"
3,false,,1,0,"quote"".ss:3"
0,true,,0,0,""
3,true,,0,0,""
