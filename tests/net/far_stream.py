# SPDX-License-Identifier: Apache-2.0
# A computer that has nothing of smc but the Python module of the dictionary: receives messages over TCP and checks them.
#         far_stream.py PORT COUNT
import socket
import sys

import sender_dictionary as link

offer = link.MESSAGES['offer']
assert offer['link'] == 'tcp' and offer['listens'] == 'sender' and offer['port'] == int(sys.argv[1])
with socket.create_connection((offer['address'], offer['port'])) as s, s.makefile('rb') as stream:
    for i in range(int(sys.argv[2])):
        run, number, values = link.decode('offer', stream.read(offer['bytes']))
        assert values['square'] == values['n'] ** 2 and values['half'] == values['n'] / 2 and values['odd'] == values['n'] % 2
print(sys.argv[2], 'messages')
