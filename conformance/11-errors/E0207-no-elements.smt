spec 5.3, 5.4   A machine lists at least G and S.
-- app.sm --
[Hold]                #! E0207
.step
    p > 5: valve = true       # what is not listed follows from that
