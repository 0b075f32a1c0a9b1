spec 1.1   A file in UTF-16 is not read.

-- app.sm --
ÿþ #! E0104 UTF-16
