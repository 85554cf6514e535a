#!/bin/sh
# Never ends, and hears no signal; what it starts goes on without it.
trap '' TERM INT HUP
(setsid sleep 600 &)
while :; do sleep 600; done
