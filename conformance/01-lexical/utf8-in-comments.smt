spec 1.2  Comments can contain any UTF-8 text.

-- app.sm --
[state_vector]
U64 G
U32 S
F64 x

[Run]
.step
    x = 20   # 20 °C, Δp = 3 bar, 𝄞, 日本
    # „Zitat“

-- app.ss --
[options]
delta_t 1

[all_states]
true {
    @assert x == 20   # ≈ 20
    @stop
}
