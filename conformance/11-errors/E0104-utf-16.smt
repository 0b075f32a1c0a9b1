spec 1.1, 1.5   A file that is no text at all is one mistake.

-- app.sm --
ÿþ[   #! E0104 UTF-16
x = 1
