# The page of a diagnostic, by code or by the name behind -W.
args explain E0204
args explain w0750
args explain unused-element | head -n 1

-- stdout --
E0204: unknown element '...'

This name is not an element listed in [state_vector], not a local and not T.

    [state_vector]
    bool valveOpen
    [Vent]
    .step
        valve0pe = true      # E0204: a zero instead of the letter O

Check the spelling. Or add it: an element to [state_vector], a value of the machine's own to [local].
W0750: this assert was never evaluated  [-Wunjudged-assert]

The script ended and this @assert was never evaluated. It has tested nothing. The message gives the reason:
its condition was never true, the machine was never in the state of its section, or the script stopped before.

    [all_states]
    G == 15: @assert valveOpen            # W0750 when delta_t is 10
    G == 100: @stop

Correct the condition, or let the script run until it is true. An @assert false states that its condition must
never be true, and causes no warning:

    [Start]
    T > 400: @assert false                # the state must be left before
unused-element: an element that the machine lists and does not use
