spec 5.3, 5.4  A machine without [state_vector] has neither G nor S.

-- app.sm --
[Run]   #! E0207
.step
