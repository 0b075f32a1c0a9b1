[digital]
o 13 lamp
