# A machine whose file bears a name of the runtime's steps aside.
args build --emit=c sm.sm && grep -c 'MSmStatus m_sm_step(MSm' sm.h

-- sm.sm --
[state_vector]
U64 G
U32 S
bool open
[Idle]
.step
    open = true
-- stdout --
1
