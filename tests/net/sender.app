[options]
state_vector "link.sv"
net "sender.net"
[main]
every 1 ms:
    task source
    send
