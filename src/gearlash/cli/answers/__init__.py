"""What commands answer, as data: frozen records that become JSON, with how they are computed. No terminal
here.
"""
