[options]
state_vector "link.sv"
net "receiver.net"
[main]
every 1 ms:
    receive
    task watch
