# The altimeter loses its wire and reads -50 m.

include "broken-altimeter.ss"

[all_states]
at 0: reading = -50
