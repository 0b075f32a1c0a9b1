spec 5.3, 5.4   An empty [state_vector] is one mistake, not two.
-- app.sm --
[state_vector]        #! E0207
[Hold]
.step
