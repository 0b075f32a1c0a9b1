spec 1.5   A file that is no text at all is one mistake.

-- app.sm --
   #! E0104 binary data
x
