// SPDX-License-Identifier: Apache-2.0
// A computer that has no part of smc except the C header of the dictionary.  It receives messages over TCP and checks them.
//         far_stream PORT COUNT
#include <arpa/inet.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/socket.h>

#include "sender_dictionary.h"

int main(int n, char **argument)
{
    struct sockaddr_in to;
    const int s = socket(AF_INET, SOCK_STREAM, 0), count = n > 2 ? atoi(argument[2]) : 1;
    uint8_t at[smc_offer_BYTES];
    smc_offer m;
    uint32_t number = 0;

    memset(&to, 0, sizeof to);
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to.sin_port = htons(smc_offer_PORT);
    if (!smc_offer_TCP || n < 2 || atoi(argument[1]) != smc_offer_PORT || connect(s, (struct sockaddr *)&to, sizeof to) != 0)
        return 3;
    for (int i = 0; i < count; i++) {
        if (recv(s, at, sizeof at, MSG_WAITALL) != (ssize_t)sizeof at || smc_offer_decode(at, sizeof at, &m) != SMC_OK)
            return 4;
        if (m.v_square != (uint64_t)m.v_n * m.v_n || m.v_half != m.v_n / 2.0 || m.v_odd != (m.v_n & 1) || (i && m.number != number + 1))
            return 5;
        number = m.number;
    }
    printf("%d messages\n", count);
    return 0;
}
