# The page of a diagnostic, by code or by the name behind -W.
args explain E0204
args explain w0750
args explain unused-element | head -n 1

-- stdout --
E0204: unknown element '...'

A name is used that is neither an element listed in [state_vector] nor a local nor T.

    [state_vector]
    bool valveOpen
    [Vent]
    .step
        valve0pe = true      # E0204: a zero for the letter O

Check the spelling, or add the element to [state_vector] or the value to [local].
W0750: this assert was never judged  [-Wunjudged-assert]

The script ended and no step made the guard of this @assert true, or its section's state was never reached: the
assert has tested nothing.

    [all_states]
    G == 15: @assert valveOpen            # W0750 when delta_t is 10
    G == 100: @stop

Correct the guard, or let the script run on until it is true. What must never be so is asserted at every step, not where it
would have happened:

    [Start]
    T > 400: @assert false                # W0750 as long as all is well
    true: @assert T <= 400
unused-element: an element that is listed and not used
