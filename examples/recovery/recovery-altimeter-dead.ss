# The altimeter reads 0.

include "broken-altimeter.ss"
