spec 11.19  Messages need their tasks.

-- rocket.app --
[options]
state_vector "rocket.sv"
net "rocket.net"
[flight]
every 10 ms:
    send
-- rocket.sv --
[A]
U32  free
U32  other
-- rocket.net --
send f every 20 ms to 10.0.0.2:1 { free }
receive a on 5001 { other }                #! W1200 messages to receive
